package robotran.workshop.assignment

import robotran.assignments.messages.ReportMessages
import robotran.language.Language

/** Tells the author's file from that for pupils, so that the wrong one is not given away. */
internal val Language.teacherSuffix: String get() = " " + ReportMessages.of(this).withSolution()
