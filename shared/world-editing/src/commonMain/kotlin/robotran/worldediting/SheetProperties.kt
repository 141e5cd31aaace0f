package robotran.worldediting

import robotran.editing.rounded
import robotran.world.World

/** The editable properties of a world as a whole; see [World]. */
data class SheetProperties(
    val title: String,
    val task: String,
    val width: Double,
    val height: Double,
    val ambientLight: Double,
    val temperature: Double,
    val timeLimit: Int,
    val realism: Double,
    val seed: Int,
)

val World.parameters: SheetProperties
    get() = SheetProperties(title, task, paper.width, paper.height, ambientLight, temperature, timeLimit, realism, seed)

internal fun World.with(parameters: SheetProperties): World = copy(
    title = parameters.title,
    task = parameters.task,
    paper = paper.copy(width = rounded(parameters.width), height = rounded(parameters.height)),
    ambientLight = rounded(parameters.ambientLight),
    temperature = rounded(parameters.temperature),
    timeLimit = parameters.timeLimit,
    realism = rounded(parameters.realism),
    seed = parameters.seed,
)
