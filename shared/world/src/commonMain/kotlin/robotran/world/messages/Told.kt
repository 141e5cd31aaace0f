package robotran.world.messages

import robotran.language.Language

internal fun told(reason: WorldFileMessages.() -> String): (Language) -> String = { WorldFileMessages.of(it).reason() }
