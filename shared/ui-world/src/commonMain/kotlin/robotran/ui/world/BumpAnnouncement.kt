package robotran.ui.world

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.world.TouchKind
import robotran.world.World

/** Announces each bump to screen readers; draws nothing. */
@Composable
internal fun BumpAnnouncement(world: World, session: SessionState) {
    val bumps = session.robots.map { it.bumps }
    var before by remember { mutableStateOf(bumps) }
    var bump: Bump? by remember { mutableStateOf(null) }
    if (bumps != before) {
        val robot = bumps.indices.firstOrNull { bumps[it] > (before.getOrNull(it) ?: 0) }
        bump = robot?.let { Bump(world.robots[it].name, bumps[it], session.robots[it].robot.touching.firstOrNull()) }
        before = bumps
    }
    val words = bump?.let { bumpWords(it) }.orEmpty()
    Box(
        Modifier.size(1.dp).testTag(WorldTags.BUMP).semantics {
            liveRegion = LiveRegionMode.Polite
            contentDescription = words
        },
    )
}

/** @property count the number of the robot's bumps so far, so that a second bump at the same wall is announced, too. */
private data class Bump(val robot: String, val count: Int, val touched: TouchKind?)

@Composable
private fun bumpWords(bump: Bump): String {
    val touched = bump.touched ?: return SheetTexts.bump(spoken, bump.count, bump.robot)
    return SheetTexts.bumpInto(spoken, bump.count, bump.robot, touched.words(spoken))
}

private val TouchKind.words: Label
    get() = when (this) {
        TouchKind.WALLS -> SheetTexts::touchWall
        TouchKind.BARRIERS -> SheetTexts::touchBarrier
        TouchKind.BLOCKS -> SheetTexts::touchBlock
        TouchKind.ROBOTS -> SheetTexts::touchRobot
    }
