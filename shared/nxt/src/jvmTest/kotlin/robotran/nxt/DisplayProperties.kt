package robotran.nxt

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.char
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll
import robotran.nxt.display.BitBlt
import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.display.NxtDisplay
import robotran.nxt.display.Picture

class DisplayProperties :
    StringSpec({
        val anyText = Arb.list(Arb.char(' '..'~'), 0..20).map { it.joinToString("") }
        val anyBytes = Arb.byteArray(Arb.constant(DisplaySize.BYTES), Arb.byte())
        val anyPlace = Arb.int(-120..120)

        "a text is read back wherever it is drawn, also white on black" {
            checkAll(2_000, anyText, Arb.int(-3..17), Arb.int(0..7), Arb.boolean()) { text, column, row, inverted ->
                val memory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
                Drawing.drawString(memory, text, column, row, inverted)
                val expected = (" ".repeat(maxOf(0, column)) + text.drop(maxOf(0, -column))).take(DisplaySize.COLUMNS)
                NxtDisplay.of(memory).lines[row] shouldBe expected.trimEnd()
            }
        }

        "text never leaves its row of cells" {
            checkAll(500, anyText, Arb.int(-3..17), Arb.int(-2..9)) { text, column, row ->
                val memory = ByteArrayMemory(ByteArray(DisplaySize.BYTES))
                Drawing.drawString(memory, text, column, row)
                val lines = NxtDisplay.of(memory).lines
                lines.filterIndexed { index, line -> index != row && line.isNotEmpty() } shouldBe emptyList()
            }
        }

        "any picture has eight lines of at most sixteen characters, and its art draws it again" {
            checkAll(500, anyBytes) { bytes ->
                val display = NxtDisplay.of(ByteArrayMemory(bytes))
                display.lines.size shouldBe DisplaySize.ROWS
                display.lines.all { it.length <= DisplaySize.COLUMNS } shouldBe true
                val rows = display.toArt().lines()
                for (x in 0..<DisplaySize.WIDTH) {
                    for (y in 0..<DisplaySize.HEIGHT) (rows[y][x] == '#') shouldBe display.isBlack(x, y)
                }
            }
        }

        "bitBlt does dot by dot what its operation says, and nothing outside" {
            checkAll(300, anyBytes, anyBytes, anyPlace, anyPlace, Arb.int()) { source, target, at, to, operation ->
                val before = NxtDisplay.of(ByteArrayMemory(target))
                val drawn = NxtDisplay.of(ByteArrayMemory(source))
                val memory = ByteArrayMemory(target.copyOf())
                val part = BitBlt(at, at / 2, to, to / 2, width = 37, height = 21, operation)
                part.draw(screen(ByteArrayMemory(source)), screen(memory))
                val after = NxtDisplay.of(memory)
                for (x in 0..<DisplaySize.WIDTH) {
                    for (y in 0..<DisplaySize.HEIGHT) {
                        val sourceX = x - to + at
                        val sourceY = y - to / 2 + at / 2
                        val isInside = x - to in 0..<37 && y - to / 2 in 0..<21 &&
                            sourceX in 0..<DisplaySize.WIDTH && sourceY in 0..<DisplaySize.HEIGHT
                        val d = if (before.isBlack(x, y)) 1 else 0
                        val s = if (isInside && drawn.isBlack(sourceX, sourceY)) 1 else 0
                        val wanted = if (isInside) combined(d, s, operation) else d
                        (if (after.isBlack(x, y)) 1 else 0) shouldBe wanted
                    }
                }
            }
        }
    })

private fun screen(memory: ByteArrayMemory) = Picture(memory, DisplaySize.WIDTH, DisplaySize.HEIGHT)

private fun combined(d: Int, s: Int, operation: Int): Int =
    (d and s and (operation ushr 24)) xor (d and (operation ushr 16)) xor (s and (operation ushr 8)) xor operation and 1
