package robotran.workshop.platform

import robotran.language.Language

/** The language of the machine as the process began, such as `de-AT`. */
expect fun machineLanguage(): String

/** The language that the app speaks if [chosen] is: the machine's if that is one of ours, else English. */
fun spokenLanguage(chosen: Language?): Language = chosen ?: Language.of(machineLanguage()) ?: Language.ENGLISH
