package robotran.projects.messages

import robotran.language.Language

internal fun reason(sentence: ProjectMessages.() -> String): (Language) -> String = {
    ProjectMessages.of(it).sentence()
}
