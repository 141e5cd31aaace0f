package robotran.workshop.platform

import robotran.language.Language

/** The system language when the process started, such as `de-AT`. */
expect fun machineLanguage(): String

/** The app language: [chosen] if set, else the system language if supported, else English. */
fun spokenLanguage(chosen: Language?): Language = chosen ?: Language.of(machineLanguage()) ?: Language.ENGLISH
