package robotran.ui.documents

import robotran.ui.resources.Res
import robotran.ui.resources.documents_unexpected
import robotran.ui.workshop.Notice

/** Says that something went wrong that nobody has thought of, and that the work is kept. */
fun unexpectedNotice(): Notice = Notice(Res.string.documents_unexpected, bad = true)
