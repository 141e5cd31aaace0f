package robotran.cli.hub

import robotran.brick.kind.BrickKind
import robotran.cli.files.ROBOLANG
import robotran.cli.files.TextFile
import robotran.cli.files.isNamed
import robotran.cli.input.readRobolangText
import robotran.language.Language
import robotran.robolang.brickOfRobolang

/**
 * The hub with Pybricks that the only one of [programs] is for: [brick] or, if that is not given, the one that its header
 * names; null if it is for no hub.
 */
internal fun hubOf(programs: List<String>, brick: BrickKind?, language: Language): BrickKind? =
    brickOf(programs, brick, language)?.takeIf { it.isHub }

/** The same for a hub or a micro:bit, whichever runs Python. */
internal fun pythonBrickOf(programs: List<String>, brick: BrickKind?, language: Language): BrickKind? =
    brickOf(programs, brick, language)?.takeIf { it.isHub || it.isBoard }

private fun brickOf(programs: List<String>, brick: BrickKind?, language: Language): BrickKind? {
    if (brick != null) return brick
    val name = programs.distinct().singleOrNull()?.takeIf { isNamed(it, ROBOLANG) } ?: return null
    val text = (readRobolangText(name, language) as? TextFile.Success)?.text ?: return null
    return brickOfRobolang(text)
}
