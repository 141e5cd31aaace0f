package robotran.world.messages

import robotran.language.Language

internal fun reason(sentence: WorldFileMessages.() -> String): (Language) -> String = {
    WorldFileMessages.of(it).sentence()
}
