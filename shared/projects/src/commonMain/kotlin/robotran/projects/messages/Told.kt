package robotran.projects.messages

import robotran.language.Language

internal fun told(reason: ProjectMessages.() -> String): (Language) -> String = { ProjectMessages.of(it).reason() }
