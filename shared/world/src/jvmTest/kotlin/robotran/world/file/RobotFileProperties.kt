package robotran.world.file

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.world.messages.sentence
import robotran.world.robot.robotErrors

class RobotFileProperties :
    StringSpec({
        val files = robotTexts.values + FULL_ROBOT

        "a robot is refused in a sentence, or read as it was written" {
            var possible = 0
            var impossible = 0
            checkAll(2_000, arbitraryRobots()) { robot ->
                val errors = robotErrors(robot)
                val result = readRobot(writeRobot(robot), Language.ENGLISH)
                if (errors.isEmpty()) {
                    possible++
                    result shouldBe RobotFileResult.Success(robot)
                } else {
                    impossible++
                    holds(result)
                    (result is RobotFileResult.Failure) shouldBe true
                    errors.all { it.sentence(Language.ENGLISH).endsWith(".") } shouldBe true
                }
            }
            possible shouldBeGreaterThan 300
            impossible shouldBeGreaterThan 300
        }

        "any text and any bytes at all give a result" {
            checkAll(Arb.string(0..200)) { holds(readRobot(it, Language.ENGLISH)) }
            checkAll(Arb.byteArray(Arb.int(0..200), Arb.byte())) { holds(readRobot(it, Language.ENGLISH)) }
        }

        "a robot file with a piece cut out gives a result" {
            checkAll(Arb.element(files), Arb.int(0..100_000), Arb.int(0..60)) { file, place, length ->
                val from = place % file.length
                holds(readRobot(file.removeRange(from, minOf(file.length, from + length)), Language.ENGLISH))
            }
        }

        "a robot file with any character changed gives a result" {
            checkAll(Arb.element(files), Arb.int(0..100_000), Arb.string(1)) { file, place, character ->
                val from = place % file.length
                holds(readRobot(file.replaceRange(from, from + 1, character), Language.ENGLISH))
            }
        }

        val others = Arb.choice(
            Arb.double().map { it.toString() },
            Arb.element("null", "[]", "{}", "true", "\"\"", "1e308", "-1e-400", "NaN", "[[[", "\"A\"", "\"down\""),
            Arb.element("-0", "0.0004", "359.99999999999999", "[0,1]", "\"rcx\"", "\"light\"", "3", "-3"),
            Arb.constant("9".repeat(1000)),
        )

        "a robot file with any of its values replaced gives a result" {
            val values = valuesIn(FULL_ROBOT)
            checkAll(2_000, Arb.element(values), others) { range, other ->
                holds(readRobot(FULL_ROBOT.replaceRange(range, other), Language.ENGLISH))
            }
        }

        "a robot file with any of its lines left out, doubled or moved gives a result" {
            checkAll(1_000, Arb.element(files), Arb.int(0..1_000), Arb.int(0..1_000), Arb.boolean()) {
                file,
                one,
                other,
                stays,
                ->
                val lines = file.lines().toMutableList()
                val line = lines[one % lines.size]
                if (!stays) lines.removeAt(one % lines.size)
                if (other % 3 > 0) lines.add(other % (lines.size + 1), line)
                holds(readRobot(lines.joinToString("\n"), Language.ENGLISH))
            }
        }

        "a damaged file is refused in a sentence of each language, about the same place" {
            checkAll(500, Arb.element(valuesIn(FULL_ROBOT)), others) { range, other ->
                val text = FULL_ROBOT.replaceRange(range, other)
                val results = Language.entries.map { readRobot(text, it) }
                val refused = results.filterIsInstance<RobotFileResult.Failure>()
                refused.map { it.path to it.line }.distinct().size shouldBe if (refused.isEmpty()) 0 else 1
                refused.size shouldBe if (refused.isEmpty()) 0 else results.size
                refused.all { it.message.endsWith(".") } shouldBe true
            }
        }

        "a damaged robot or draft in a world gives a result" {
            val robot = FULL_ROBOT.replace(Regex("\"(format|version)\":[^,]*,"), "")
            val world = """{ "format": "robotran-world", "version": 2, "title": "Damaged", "paper": { "width": 90, "height": 90 },
                "robots": [{ "start": { "x": 45, "y": 45, "heading": 0 }, "robot": $robot, "draft": $robot }] }"""
            var read = 0
            checkAll(2_000, Arb.element(valuesIn(world)), others) { range, other ->
                val result = readWorld(world.replaceRange(range, other), Language.ENGLISH)
                holds(result)
                // Only a draft may be impossible.
                val robots = (result as? WorldFileResult.Success)?.world?.robots ?: return@checkAll
                read++
                robots.all { robotErrors(it.description).isEmpty() } shouldBe true
            }
            read shouldBeGreaterThan 100
        }
    })
