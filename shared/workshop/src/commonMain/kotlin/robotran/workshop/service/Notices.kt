package robotran.workshop.service

import robotran.workshop.state.Notice

/** Shows messages to the pupil. */
interface Notices {
    /** Shows [notice] until it is dismissed or replaced. */
    fun show(notice: Notice)

    /** Adds [warnings], localised sentences about a file, to the notice that is shown, or shows them alone. */
    fun add(warnings: List<String>)

    /** Dismisses the notice that is shown if it [isOver]; warnings that were added to it stay. */
    fun dismissIf(isOver: (Notice) -> Boolean)
}
