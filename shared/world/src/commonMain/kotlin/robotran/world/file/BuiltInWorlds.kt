package robotran.world.file

import robotran.world.World

/** The worlds that come with Robotran: the files of the folder `worlds`. */
object BuiltInWorlds {
    /** The text of each world file by its name, such as `plain.world.json`. */
    val texts: Map<String, String> get() = worldTexts

    /**
     * A bare sheet with four walls around it and nothing to be reached: where everything begins when no other world is
     * asked for.
     */
    val plain: World by lazy(LazyThreadSafetyMode.PUBLICATION) {
        when (val result = readWorld(texts.getValue("plain.world.json"))) {
            is WorldFileResult.Loaded -> result.world.copy(task = "", goals = emptyList())
            is WorldFileResult.Rejected -> error(result.message)
        }
    }
}
