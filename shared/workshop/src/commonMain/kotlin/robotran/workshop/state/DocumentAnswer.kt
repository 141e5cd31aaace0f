package robotran.workshop.state

/** What to do when something could be lost. */
enum class DocumentAnswer {
    /** Do it nevertheless. */
    GO_ON,

    /** Save to another file, which is chosen. */
    SAVE_AS,

    /** Take what is in the file now in place of the work. */
    TAKE_THEIRS,
}
