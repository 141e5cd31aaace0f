package robotran.worldediting

import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import robotran.language.Language
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.file.writeWorld

class EditingProperties :
    StringSpec({
        val builtIn = BuiltInWorlds.texts.values.map {
            (readWorld(it, Language.ENGLISH) as WorldFileResult.Success).world
        }
        val worlds: Arb<World> = Arb.element(builtIn + newWorld("New"))
        val edits = Arb.list(arbitrary { ArbitraryEdits(it.random).edit() }, 0..60)

        "undoing everything gives the world as it was, and redoing everything the world as it became" {
            checkAll(300, worlds, edits) { world, list ->
                val first = WorldEditing.of(world)
                val last = list.fold(first) { now, edit -> now.after(edit) }.after(WorldEdit.Drop)
                val steps = last.history.past.size
                val undone = (1..steps).fold(last) { now, _ -> now.after(WorldEdit.Undo) }
                undone.world shouldBe world
                (1..undone.history.future.size).fold(undone) { now, _ ->
                    now.after(WorldEdit.Redo)
                }.history.future.isEmpty() shouldBe
                    true
            }
        }

        "a world without troubles is read as it was written, and one with troubles is refused" {
            checkAll(300, worlds, edits) { world, list ->
                val editing = list.fold(WorldEditing.of(world)) { now, edit -> now.after(edit) }.after(WorldEdit.Drop)
                val result = readWorld(writeWorld(editing.world), Language.ENGLISH)
                if (editing.errors.isEmpty()) result shouldBe WorldFileResult.Success(editing.world)
                (result is WorldFileResult.Failure) shouldBe editing.errors.isNotEmpty()
                editing.errors.filterIsInstance<ValidationError.Rejected>() shouldBe emptyList()
            }
        }

        "what is chosen and grouped is always there" {
            checkAll(200, worlds, edits) { world, list ->
                val editing = list.fold(WorldEditing.of(world)) { now, edit -> now.after(edit) }
                (editing.selection + editing.groups.flatten()).filter { editing.world.piece(it) == null } shouldBe
                    emptyList()
                editing.groups.flatten().size shouldBe editing.groups.flatten().toSet().size
            }
        }
    })
