package robotran.ui.program.blocks

import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import robotran.robolang.words.BlockGroup
import robotran.ui.program.tags.ProgramTags
import robotran.ui.run.tags.RunTags
import robotran.ui.screen.assertUnmoved
import robotran.ui.screen.assertWhole
import robotran.ui.screen.checkTargets
import robotran.ui.screen.isThere
import robotran.ui.screen.onScreen
import robotran.ui.screen.placesByTag
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.scrollTo
import robotran.ui.screen.touch
import robotran.workshop.Workshop
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests that blocks and their sheets fit on screens of [sizes], and that nothing moves that shall not. */
@OptIn(ExperimentalTestApi::class)
abstract class BlocksOnScreens {
    internal abstract val sizes: List<Size>

    @Test
    fun `the whole sheet of a number is reached without scrolling`() {
        for (size in sizes) {
            inBlocks(size, LINES) {
                touch(socketOf(LINES, "20"))
                assertWholePad("$size")
                assertWhole(ProgramTags.NUMBER_SLIDER, "$size")
                touch(ProgramTags.BLOCK_SHEET_CLOSE)
                scrollAndTouch(socketOf(LINES, "90"))
                assertWholePad("$size, dial")
                if (!size.isLow) assertWhole(ProgramTags.NUMBER_DIAL, "$size")
            }
        }
    }

    @Test
    fun `a program with mistakes has the whole sheet of a number, too, and tells of them when it closes`() {
        for (size in sizes) {
            inBlocks(size, MISTAKEN) {
                assertEquals(!size.isLow, isThere(ProgramTags.MISTAKES), "$size")
                touch(socketOf(MISTAKEN, "20"))
                assertWholePad("$size")
                assertWhole(ProgramTags.NUMBER_SLIDER, "$size")
                touch(ProgramTags.NUMBER_DONE)
                assertEquals(!size.isLow, isThere(ProgramTags.MISTAKES), "$size")
            }
        }
    }

    @Test
    fun `the palette has room for its search, its groups and blocks`() {
        for (size in sizes) {
            inBlocks(size, MISTAKEN) {
                val add = ProgramTags.BLOCKS_ADD
                touch(if (isThere(add)) add else ProgramTags.group(BlockGroup.DRIVE))
                for (tag in listOf(ProgramTags.PALETTE_SEARCH, ProgramTags.take("move"))) assertWhole(tag, "$size")
                if (!size.isLow) return@inBlocks
                for (group in BlockGroup.entries) {
                    assertWhole(ProgramTags.group(group), "$size")
                    checkTargets(ProgramTags.group(group))
                }
                touch(ProgramTags.group(BlockGroup.SENSE))
                scrollTo(ProgramTags.take("value-light"))
                assertWhole(ProgramTags.take("value-light"), "$size")
                touch(ProgramTags.BLOCK_SHEET_CLOSE)
                assertTrue(isThere(ProgramTags.UNDO), "$size")
            }
        }
    }

    @Test
    fun `a sheet that opens and closes and a value that changes move no other block`() {
        for (size in sizes) {
            inBlocks(size, FIRST) { workshop ->
                val before = placesByTag().filterKeys { tag ->
                    BLOCK.matches(tag) || tag == ProgramTags.program(0) || tag == RunTags.RUN
                }
                // A phone in landscape has room for nothing else than the sheet.
                val visible = if (size.isLow) setOf("run") else before.keys
                touch(socketOf(FIRST, "20"))
                assertUnmoved(before, visible, "$size: the sheet has opened")
                touch(ProgramTags.digit('3'))
                touch(ProgramTags.NUMBER_MORE)
                assertEquals(FIRST.replaceFirst("20", "4"), workshop.text)
                assertUnmoved(before, visible - ProgramTags.block("0"), "$size: the number is another one")
                touch(ProgramTags.BLOCK_SHEET_CLOSE)
                assertUnmoved(before, before.keys - ProgramTags.block("0"), "$size: the sheet has closed")
            }
        }
    }

    @Test
    fun `a block that is touched does not move, and has a button for what can be done`() {
        for (size in sizes) {
            inBlocks(size, LINES) {
                val before = placesByTag().filterKeys { it.startsWith("block-") || it.startsWith("socket-") }
                touch(ProgramTags.block("0"))
                assertUnmoved(before, before.keys, "$size")
                checkTargets(ProgramTags.BLOCK_MORE, ProgramTags.block("0"))
            }
        }
    }

    @Test
    fun `groups are a rail on tablets and laptops, and part of the sheet on phones`() {
        for (size in sizes) {
            inBlocks(size, LINES) {
                val hasRail = isThere(ProgramTags.BLOCK_GROUPS)
                assertEquals(size.isPhone, !hasRail, "$size")
                assertEquals(hasRail, !isThere(ProgramTags.BLOCKS_ADD), "$size")
            }
        }
    }

    @Test
    fun `all that can be touched in blocks and sheets is large enough`() {
        for (size in sizes) {
            inBlocks(size, LINES) {
                assertLargeEnough("$size")
                touch(socketOf(LINES, "20"))
                assertLargeEnough("$size, number")
                touch(ProgramTags.BLOCK_SHEET_CLOSE)
                scrollAndTouch(socketOf(LINES, "left"))
                assertLargeEnough("$size, choice")
            }
        }
    }

    @Test
    fun `a long condition wraps inside of its block`() {
        for (size in sizes) {
            inBlocks(size, LONG) {
                val places = placesByTag()
                val block = places.getValue(ProgramTags.block("0"))
                val sockets = places.filter { (tag, place) -> tag.startsWith("socket-") && !place.isEmpty }
                assertTrue(sockets.isNotEmpty(), "$size")
                for ((tag, place) in sockets) {
                    val isInside = place.left >= block.left && place.right <= block.right &&
                        place.top >= block.top && place.bottom <= block.bottom
                    assertTrue(isInside, "$size: $tag is at $place of $block")
                }
                assertTrue(block.right <= size.width, "$size: the block ends at ${block.right}")
                assertLargeEnough("$size")
            }
        }
    }

    private fun ComposeUiTest.assertWholePad(described: String) {
        val digits = ('0'..'9').map { ProgramTags.digit(it) }
        for (tag in digits + listOf(
            ProgramTags.NUMBER_NOW,
            ProgramTags.NUMBER_LESS,
            ProgramTags.NUMBER_MORE,
            ProgramTags.NUMBER_DONE,
        )) {
            assertWhole(tag, described)
        }
        checkTargets(ProgramTags.NUMBER_LESS, ProgramTags.NUMBER_MORE, ProgramTags.NUMBER_DONE, *digits.toTypedArray())
    }

    private fun ComposeUiTest.assertLargeEnough(described: String) {
        val nodes = onAllNodes(SemanticsMatcher.keyIsDefined(SemanticsProperties.TestTag)).fetchSemanticsNodes()
        for (node in nodes) {
            val tag = node.config[SemanticsProperties.TestTag]
            val isWhole = node.size.height - node.boundsInRoot.height < 1f
            if (!isWhole || TOUCHED.none { tag.startsWith(it) }) continue
            val place = node.touchBoundsInRoot
            assertTrue(place.width >= 48f && place.height >= 48f, "$described: $tag is only ${place.size}")
        }
    }

    private fun inBlocks(size: Size, text: String, check: ComposeUiTest.(Workshop) -> Unit) =
        onScreen(size.width, size.height) { workshop ->
            showInBlocks(workshop, text)
            check(workshop)
        }

    internal data class Size(val width: Int, val height: Int) {
        val isPhone: Boolean get() = minOf(width, height) < 600

        /** There is no room for a dial. */
        val isLow: Boolean get() = height < 480
    }

    private companion object {
        /** A low pane scrolls for other lines than the first when a sheet opens. */
        const val FIRST = "forward 20\nturn left 90\nbeep\n"
        const val LINES = "beep\nforward 20\nturn left 90\n"
        const val MISTAKEN = "forward 20\nturn left 90\nforwrd 5\n"
        const val LONG = "if left bumper and not right bumper or light < 40 and battery > 7000\n  beep\nend\n"
        val BLOCK = Regex("block-\\d+")
        val TOUCHED =
            listOf(
                "block-line",
                ProgramTags.block("0"),
                ProgramTags.block("1"),
                "socket-",
                "digit-",
                ProgramTags.NUMBER_LESS,
                "choice-",
                "group-",
            )
    }
}
