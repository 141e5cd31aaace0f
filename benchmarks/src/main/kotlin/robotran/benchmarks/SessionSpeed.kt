package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import robotran.world.BuiltInWorlds
import robotran.world.Session
import robotran.world.physics.loadPhysicsEngine
import robotran.world.runUnattended

/** How many times faster than real time a robot draws squares on an empty sheet. */
internal fun sessionSpeed(): String {
    val program = programOf("pen down\nrepeat 1000 times\n  forward 20\n  turn left 90\nend\n")
    val seconds =
        secondsOf {
            val session = runBlocking { Session(BuiltInWorlds.plain, listOf(program), loadPhysicsEngine()) }
            session.runUnattended(VIRTUAL_SECONDS * 1000)
            session.close()
        }
    return "%.0f times real time (%d virtual seconds in %.3f s)".format(VIRTUAL_SECONDS / seconds, VIRTUAL_SECONDS, seconds)
}

private const val VIRTUAL_SECONDS = 600
