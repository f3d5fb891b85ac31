; Remarks over several lines. Loops are blocks one after the other, which no query can pair: editors/vim/ftplugin/fanuc.vim does.
(comment)+ @fold
