; Remarks over several lines. Structures are blocks one after the other, which no query can pair.
(comment)+ @fold
