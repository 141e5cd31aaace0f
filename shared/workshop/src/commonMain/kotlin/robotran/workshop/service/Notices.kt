package robotran.workshop.service

import robotran.workshop.state.Notice

/** Shows messages to the pupil. */
interface Notices {
    /** Shows [notice] until it is dismissed or replaced. */
    fun show(notice: Notice)
}
