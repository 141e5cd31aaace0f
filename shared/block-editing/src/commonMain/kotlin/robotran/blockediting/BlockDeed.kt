package robotran.blockediting

/** What an edit has done, for a screen reader. */
enum class BlockDeed { ADDED, MOVED, DOUBLED, DELETED, CHANGED }
