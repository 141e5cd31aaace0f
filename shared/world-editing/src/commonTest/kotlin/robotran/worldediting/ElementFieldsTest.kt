package robotran.worldediting

import robotran.editing.Field
import robotran.editing.ungrouped
import robotran.world.geometry.Point
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ElementFieldsTest {
    private val made = PaletteItem.entries.map { item ->
        val sheet = emptySheet()
        sheet.after(WorldEdit.Put(item.piece(sheet.world), Point(60.0, 40.0)))
    }

    private fun fieldsOf(editing: WorldEditing) =
        editing.fieldsOf(checkNotNull(editing.only)) { port, _ -> { "$port" } }.ungrouped()

    @Test
    fun `each field of an element has a tag of its own and a valid value`() {
        for (editing in made) {
            val fields = fieldsOf(editing)
            val tags = fields.map { it.tag }.filter { it.isNotEmpty() }
            assertEquals(tags.distinct(), tags)
            assertTrue(fields.all { it.isValid }, "${editing.only}")
        }
    }

    @Test
    fun `a number beside its place is refused beyond its limits`() {
        for (editing in made) {
            val piece = checkNotNull(editing.world.piece(checkNotNull(editing.only)))
            for (field in ownFields(piece).ungrouped().filterIsInstance<Field.Number<Element>>()) {
                if (field.spec.isWhole) continue
                val beyond = checkNotNull(field.with(field.spec.range.endInclusive * 2 + 1))
                assertEquals(WorldEditError.OutOfRange, errorOf(beyond), field.tag)
            }
        }
    }

    @Test
    fun `the sheet as a whole has valid fields`() {
        assertTrue(fieldsOf(emptySheet().world.parameters).all { it.isValid })
    }
}
