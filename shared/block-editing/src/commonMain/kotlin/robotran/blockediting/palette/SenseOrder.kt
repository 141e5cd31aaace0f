package robotran.blockediting.palette

import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueForm

/** The place of the block among those of its group; blocks of the same rank keep their order. */
internal val PaletteBlock.rankInGroup: Int
    get() = if (group == BlockGroup.SENSE) SENSE_ORDER.indexOf(id).let { if (it < 0) SENSE_ORDER.size else it } else 0

/** What pupils need first: the values of sensors, then where they are plugged in. */
private val SENSE_ORDER: List<String> = listOf(
    ValueForm.BUMPER,
    ValueForm.LIGHT,
    ValueForm.DISTANCE,
    ValueForm.COLOUR,
    ValueForm.COLOUR_NAME,
    ValueForm.LOUDNESS,
    ValueForm.TURNED,
    ValueForm.TIMER,
    ValueForm.BUTTON,
    ValueForm.SENSOR,
    ValueForm.BATTERY,
).map { idOf(it) } + listOf(
    LineForm.ROBOT,
    LineForm.BRICK,
    LineForm.LIGHT_SENSOR,
    LineForm.SONAR,
    LineForm.COLOUR_SENSOR,
    LineForm.SOUND_SENSOR,
    LineForm.RESET_TIMER,
    LineForm.RESET_MOTOR,
).map { idOf(it) }
