package robotran.workshop.sound

import robotran.runcontrol.RunPlayer
import robotran.runcontrol.RunSpeed
import robotran.runsound.RunSound
import robotran.runsound.RunTone
import robotran.simulation.state.SessionState
import robotran.world.World

/** Listens to a run while [isOn]. Otherwise it costs nothing. */
internal class RunEar {
    var isOn = false
    private var world: World? = null
    private var robot = 0
    private var sound: RunSound? = null
    private val heard = mutableListOf<RunTone>()
    private val look: (SessionState) -> Unit = { state -> sound?.let { heard += it.observe(state) } }

    /** Listens to the watched robot of [player] in [world]. At the highest speed there is nothing to be heard. */
    fun follow(player: RunPlayer, world: World) {
        val hears = isOn && player.speed != RunSpeed.FASTEST
        player.onLook = look.takeIf { hears }
        if (!hears) {
            sound = null
        } else if (sound == null || world !== this.world || player.watched != robot) {
            this.world = world
            robot = player.watched
            sound = RunSound(world, robot)
        }
    }

    /** The tones since the last call. */
    fun take(): List<RunTone> = if (heard.isEmpty()) emptyList() else heard.toList().also { heard.clear() }
}
