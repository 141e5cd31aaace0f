package robotran.workshop.state

/** What to do if changes could be lost. */
enum class DocumentAnswer {
    /** Continue and lose them. */
    GO_ON,

    /** Save to another file, chosen by the user. */
    SAVE_AS,

    /** Discard the changes and load the file's current content. */
    TAKE_THEIRS,
}
