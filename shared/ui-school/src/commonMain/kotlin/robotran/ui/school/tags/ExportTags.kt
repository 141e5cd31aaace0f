package robotran.ui.school.tags

/** The tags of showing work to others, by which tests and the page find what is on the screen. */
object ExportTags {
    const val POSTER_DATE = "poster-date"
    const val POSTER_KIND = "poster-kind"
    const val POSTER_MAKER = "poster-maker"
    const val POSTER_PREVIEW = "poster-preview"
    const val POSTER_TITLE = "poster-title"
    const val SHOW_BACK = "show-back"
    const val SHOW_CANCEL = "show-cancel"
    const val SHOW_CLOSE = "show-close"
    const val SHOW_FAILED = "show-failed"
    const val SHOW_MADE = "show-made"
    const val SHOW_MAKE = "show-make"
    const val SHOW_MAKING = "show-making"
    const val SHOW_MORE = "show-more"
    const val SHOW_PRINT = "show-print"
    const val SHOW_PROGRESS = "show-progress"
    const val SHOW_SAVE = "show-save"
    const val SHOW_SAVED = "show-saved"
    const val SHOW_SHARE = "show-share"
    const val SHOW_SHEET = "show-sheet"

    fun choice(choice: Enum<*>) = "show-${choice.name.lowercase()}"

    fun speed(factor: Int) = "show-speed-$factor"
}
