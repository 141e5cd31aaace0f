package robotran.cli.hub

import com.github.ajalt.clikt.core.UsageError
import robotran.brick.kind.BrickKind

/** Refuses [brick] where programs become images, which is for a brick that a tower reaches. */
internal fun requireImages(brick: BrickKind) {
    if (brick.hasLegoFirmware) return
    val others = BrickKind.entries.filter { it.hasLegoFirmware || it.isHub || it.isBoard }
    throw UsageError("this goes with --brick ${others.joinToString(", ") { it.word }}")
}
