package robotran.workshop.blocks

import robotran.blockediting.BlockEditError
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import kotlin.test.Test
import kotlin.test.assertEquals

class CarriedValuesTest {
    @Test
    fun `a value moves from one block to another and leaves one behind that fits`() =
        onBlocks("forward light + 5\nturn left 45\n") {
            val load = DragPayload.Value(span("forward light + 5", "light"))
            drag(load, BlockTarget.Socket(span("turn left 45", "45")))
            assertEquals("forward 5 + 5\nturn left light\n", text)
            assertEquals("turn left light", row)
            assertEquals("light", part)
            send(ProgramEvent.Undone)
            assertEquals("forward light + 5\nturn left 45\n", text)
        }

    @Test
    fun `a value that does not fit stays where it was, and a sentence says why`() =
        onBlocks("if left bumper\nend\nforward 20\n") {
            val load = DragPayload.Value(span("if left bumper", "left bumper"))
            drag(load, BlockTarget.Socket(span("forward 20", "20")))
            assertEquals("if left bumper\nend\nforward 20\n", text)
            assertEquals(BlockEditError.NumberNeeded, state.error)
        }

    @Test
    fun `a value in the bin becomes a number again`() = onBlocks("forward light * 2\n") {
        drag(DragPayload.Value(span("forward light * 2", "light * 2")), BlockTarget.Bin)
        assertEquals("forward 20\n", text)
    }

    @Test
    fun `blocks in the bin are deleted, all that are selected`() = onBlocks("beep\nbuzz\nstop\n") {
        goTo("beep")
        send(BlockEvent.SelectedTo(block("buzz")))
        drag(DragPayload.Blocks(state.runOf(block("beep"))), BlockTarget.Bin)
        assertEquals("stop\n", text)
    }

    @Test
    fun `a value of the palette goes where it is carried, and a sum keeps what is there`() = onBlocks("forward 20\n") {
        drag(DragPayload.New(fromPalette("value-light")), BlockTarget.Socket(span("forward 20", "20")))
        assertEquals("forward light\n", text)
        drag(DragPayload.New(fromPalette("value-arithmetic")), BlockTarget.Socket(span("forward light", "light")))
        assertEquals("forward light + 5\n", text)
    }

    @Test
    fun `a value of the palette goes where a sheet was opened, and without a place says what to do`() =
        onBlocks("forward 20\n") {
            take("value-light")
            assertEquals("forward 20\n", text)
            assertEquals(BlockEditError.NoPlaceForValue, state.error)
            open("forward 20", "20")
            send(BlockEvent.DialogShown(BlockDialog.Palette))
            take("value-light")
            assertEquals("forward light\n", text)
        }

    @Test
    fun `lines do not go into a value, nor values between lines`() = onBlocks("forward light\n") {
        drag(DragPayload.New(fromPalette("beep")), BlockTarget.Socket(span("forward light", "light")))
        drag(DragPayload.New(fromPalette("value-light")), BlockTarget.Between(checkNotNull(state.program.endOf(null))))
        drag(DragPayload.Value(span("forward light", "light")), BlockTarget.Between(state.placeForNew))
        assertEquals("forward light\n", text)
    }
}
