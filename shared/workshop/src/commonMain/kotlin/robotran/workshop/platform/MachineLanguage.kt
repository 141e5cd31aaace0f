package robotran.workshop.platform

import robotran.language.Language

/** The system language when the process started, such as `de-AT`. */
expect fun systemLanguage(): String

/** The app language: [chosen] if set, else the system language if supported, else English. */
fun appLanguage(chosen: Language?): Language = chosen ?: Language.of(systemLanguage()) ?: Language.ENGLISH
