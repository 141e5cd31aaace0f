package robotran.workshop.service

import robotran.workshop.state.Notice

/** Tells the pupil something in one sentence. */
interface Notices {
    /** Shows [notice] until it is read, or until another comes. */
    fun say(notice: Notice)
}
