package robotran.blockediting

import robotran.blockediting.palette.Palette
import robotran.language.source.SourceSpan
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import kotlin.random.Random

/** A random edit of [program], which may be refused. */
internal fun randomEdit(program: BlockProgram, random: Random): BlockEdit {
    val blocks = program.all
    val templates = Palette.blocks.filter { !it.isValue }
    if (blocks.isEmpty()) return BlockEdit.Insert(templates.random(random).textFor(program), BlockPlace(null, 0, 0))
    val block = blocks.random(random)
    val run = BlockRun(block.id, random.nextInt(1, 4))
    val parts = program.outline.lines[block.head.index].parts.flatMap(::withInner)
    val part = parts.randomOrNull(random)?.span ?: SourceSpan(0, 0)
    return when (random.nextInt(19)) {
        0, 1, 2 -> BlockEdit.Insert(templates.random(random).textFor(program), randomPlace(program, random))
        3, 4, 5, 6 -> BlockEdit.Move(run, randomPlace(program, random))
        7 -> BlockEdit.Duplicate(run)
        8, 9 -> BlockEdit.Delete(setOf(block.id))
        10 -> BlockEdit.Wrap(run, templates.filter { it.template.endsWith("end") }.random(random).template)
        11 -> if (block is Block.Construct) BlockEdit.Unwrap(block.id) else BlockEdit.Duplicate(run)

        12 -> {
            if (random.nextBoolean()) {
                BlockEdit.AddElse(
                    block.id,
                    "light < 40".takeIf {
                        random.nextBoolean()
                    },
                )
            } else {
                BlockEdit.RemoveElse(block.id, 1)
            }
        }

        13 -> BlockEdit.Replace(part, VALUES.random(random))
        14 -> BlockEdit.SetNote(block.lines.random(random), "note".takeIf { random.nextBoolean() })

        15 -> {
            formsFor(block.head.form ?: LineForm.END).randomOrNull(random)
                ?.let { BlockEdit.ChangeForm(block.head.index, it) } ?: BlockEdit.Duplicate(run)
        }

        16 -> BlockEdit.UseNewName(part, program.freeName("name"))

        17 -> {
            val names = program.outline.names
            val name = names.randomOrNull(random)?.declaredAt ?: part
            when (random.nextInt(3)) {
                0 -> BlockEdit.Rename(name, program.freeName("other"))
                1 -> BlockEdit.AddParameter(name, program.freeName("p"))
                else -> BlockEdit.RemoveParameter(name, 0)
            }
        }

        else -> if (random.nextInt(4) == 0) BlockEdit.ApplyFix(block.head.index) else BlockEdit.ClearValue(part)
    }
}

private fun withInner(part: PhrasePart): List<PhrasePart> =
    if (part is PhrasePart.Value) listOf(part) + part.value.parts.flatMap(::withInner) else listOf(part)

private fun randomPlace(program: BlockProgram, random: Random): BlockPlace {
    val construct = program.all.filterIsInstance<Block.Construct>().randomOrNull(random)?.takeIf {
        random.nextInt(3) > 0
    }
    val slot = construct?.slots?.indices?.random(random) ?: 0
    val count = checkNotNull(program.blocksAt(construct?.id, slot)).size
    return BlockPlace(construct?.id, slot, random.nextInt(count + 1))
}

private val VALUES =
    listOf(
        "5",
        "1",
        "-2.5",
        "left bumper",
        "timer + 1",
        "right",
        "forward",
        "x",
        "[1, 2]",
        "not (1 < 2)",
        "B",
        "2",
        "or",
    )
