package robotran.runcontrol

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.brick.program.StepKind
import robotran.language.Language
import robotran.simulation.Breakpoint
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.world.geometry.Pose

/** Any way of seeking through a run gives the run that its inputs define. */
class RunPlayerProperties :
    StringSpec({
        val acts: Arb<RunPlayer.() -> Unit> = Arb.choice(
            Arb.int(1..3_000).map { { pass(it) } },
            Arb.int(0..9_000).map { time -> { seek(time.toLong()) } },
            Arb.constant { finishSeeking() },
            Arb.constant { play() },
            Arb.constant { pause() },
            Arb.enum<StepKind>().map { kind -> { step(kind) } },
            Arb.enum<RunSpeed>().map { chosen -> { speed = chosen } },
            Arb.int(1..13).map { line -> { breakpoints = setOf(Breakpoint(line)) } },
            Arb.constant { breakpoints = emptySet() },
            Arb.constant { frames(7) },
            Arb.bind(Arb.int(20..80), Arb.int(20..40)) { x, y ->
                { apply(SessionInput.PlaceRobot(0, Pose(x.toDouble(), y.toDouble(), x.toDouble()))) }
            },
            Arb.constant { apply(SessionInput.Stop) },
            Arb.constant { pressRun() },
        )

        "random walks through a run never change what it is at a time" {
            val setup = setupOf(BUSY)
            checkAll(150, Arb.list(acts, 1..25)) { walk ->
                val player = RunPlayer(setup)
                player.pressRun()
                walk.forEach { act -> player.act() }
                val length = player.length
                for (time in listOf(length, length / 2, length / 3, length)) {
                    player.seek(time)
                    player.finishSeeking()
                    val straight = Session.replay(
                        setup.world,
                        setup.loads,
                        setup.physics,
                        player.inputs,
                        time,
                        Language.ENGLISH,
                    )
                    player.session.traceHash shouldBe straight.traceHash
                    player.state.robots shouldBe straight.state.robots
                    player.romCalls.entries shouldBe straight.callLog.entries
                    straight.close()
                }
                player.close()
            }
        }
    })
