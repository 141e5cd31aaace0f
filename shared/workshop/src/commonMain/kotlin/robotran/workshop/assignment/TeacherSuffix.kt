package robotran.workshop.assignment

import robotran.language.Language

/** Tells the author's file from that for pupils, so that the wrong one is not given away. */
internal val Language.teacherSuffix: String
    get() = when (this) {
        Language.ENGLISH -> " (with solution)"
        Language.GERMAN -> " (mit Lösung)"
        Language.SPANISH -> " (con solución)"
    }
