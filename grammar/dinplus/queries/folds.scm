; A section up to the next, comments over several lines, and runs of comments.
((section) @fold . [(block) (header_entry) (comment)]+ @fold)
(comment)+ @fold
