package robotran.cli.run

import robotran.brick.kind.BrickKind
import robotran.brick.log.CallGroup
import robotran.cli.messages.CommandMessages

/** What [outputs] and [presses] ask for that [brick], that of the first robot, does not have; null if nothing. */
internal fun missingOnBrick(
    brick: BrickKind,
    presses: List<ButtonPress>,
    outputs: RunOutputs,
    messages: CommandMessages,
): String? {
    val buttons = brick.buttons
    val groups = brick.callGroups
    val button = presses.firstOrNull { it.button !in buttons }
    val group = outputs.romLogGroups?.firstOrNull { it !in groups }
    return when {
        button != null -> messages.noButton(brick, buttonName(button.button), buttons.map(::buttonName))
        group != null -> messages.noCallGroup(brick, groupName(group), groups.map(::groupName))
        outputs.memory != null && !brick.hasRom -> messages.noMemory(brick)
        else -> null
    }
}

/** The command-line name of [group]. */
internal fun groupName(group: CallGroup): String = group.name.lowercase()
