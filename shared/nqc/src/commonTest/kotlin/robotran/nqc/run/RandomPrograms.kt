package robotran.nqc.run

import kotlin.random.Random

/** What a statement does next. */
internal enum class TestFlow { GO_ON, BREAK, CONTINUE }

/** A statement as text, and what it does to variables. */
internal class TestStatement(val text: String, val run: (MutableMap<String, Int>) -> TestFlow)

/** Makes statements with loops that end. Each loop counts with a variable of its own, `n0` and so on. */
internal class RandomPrograms(private val random: Random, private val variables: List<String>) {
    private val expressions = RandomExpressions(random, variables)

    /** The variables that loops count with. */
    val counters = mutableListOf<String>()

    fun block(depth: Int, isInLoop: Boolean = false): TestStatement {
        val statements = List(random.nextInt(1, 4)) { next(depth, isInLoop) }
        val text = statements.joinToString("\n", "{\n", "\n}") { it.text }
        return TestStatement(text) { values ->
            statements.firstNotNullOfOrNull { statement -> statement.run(values).takeIf { it != TestFlow.GO_ON } }
                ?: TestFlow.GO_ON
        }
    }

    private fun next(depth: Int, isInLoop: Boolean): TestStatement = if (depth == 0) {
        simple(isInLoop)
    } else {
        when (random.nextInt(8)) {
            0 -> branch(depth, isInLoop)
            1 -> repeat(depth)
            2 -> forLoop(depth)
            3 -> whileLoop(depth)
            4 -> doWhile(depth)
            5 -> switch(depth)
            6 -> longBranch()
            else -> simple(isInLoop)
        }
    }

    private fun simple(isInLoop: Boolean): TestStatement = when (random.nextInt(if (isInLoop) 8 else 6)) {
        0 -> update()
        1 -> step()
        6 -> leave("break", TestFlow.BREAK)
        7 -> leave("continue", TestFlow.CONTINUE)
        else -> assignment()
    }

    private fun assignment(): TestStatement {
        val name = variables.random(random)
        val value = expressions.next(2)
        return TestStatement("$name = ${value.text};") {
            it[name] = value.valueIn(it)
            TestFlow.GO_ON
        }
    }

    private fun update(): TestStatement {
        val name = variables.random(random)
        val value = expressions.next(1)
        return TestStatement("$name += ${value.text};") {
            it[name] = (it.getValue(name) + value.valueIn(it)).toShort().toInt()
            TestFlow.GO_ON
        }
    }

    private fun step(): TestStatement {
        val name = variables.random(random)
        return TestStatement("$name--;") {
            it[name] = (it.getValue(name) - 1).toShort().toInt()
            TestFlow.GO_ON
        }
    }

    private fun leave(word: String, flow: TestFlow): TestStatement {
        val condition = expressions.next(1)
        return TestStatement("if (${condition.text}) $word;") {
            if (condition.valueIn(it) != 0) flow else TestFlow.GO_ON
        }
    }

    private fun branch(depth: Int, isInLoop: Boolean): TestStatement {
        val condition = expressions.next(2)
        val then = block(depth - 1, isInLoop)
        val otherwise = if (random.nextBoolean()) block(depth - 1, isInLoop) else null
        val text = "if (${condition.text}) ${then.text}" + otherwise?.let { " else ${it.text}" }.orEmpty()
        return TestStatement(text) {
            if (condition.valueIn(it) != 0) then.run(it) else otherwise?.run?.invoke(it) ?: TestFlow.GO_ON
        }
    }

    private fun repeat(depth: Int): TestStatement {
        val count = random.nextInt(4)
        val body = block(depth - 1, isInLoop = true)
        // Firmware 1.0 has one loop counter, which a break leaves behind; NQC does not care.
        return TestStatement("repeat ($count) ${body.text}") { values -> rounds(count) { body.run(values) } }
    }

    private fun forLoop(depth: Int): TestStatement {
        val counter = counter()
        val count = random.nextInt(4)
        val body = block(depth - 1, isInLoop = true)
        return TestStatement("for ($counter = 0; $counter < $count; $counter++) ${body.text}") { values ->
            rounds(count) { body.run(values) }
        }
    }

    private fun whileLoop(depth: Int): TestStatement {
        val counter = counter()
        val count = random.nextInt(4)
        val body = block(depth - 1, isInLoop = true)
        return TestStatement("$counter = $count; while ($counter-- > 0) ${body.text}") { values ->
            rounds(count) { body.run(values) }
        }
    }

    private fun doWhile(depth: Int): TestStatement {
        val counter = counter()
        val count = random.nextInt(1, 4)
        val body = block(depth - 1, isInLoop = true)
        return TestStatement("$counter = 0; do ${body.text} while (++$counter < $count);") { values ->
            rounds(count) { body.run(values) }
        }
    }

    private fun rounds(count: Int, body: () -> TestFlow): TestFlow {
        for (round in 0 until count) if (body() == TestFlow.BREAK) break
        return TestFlow.GO_ON
    }

    private fun switch(depth: Int): TestStatement {
        val selector = expressions.next(1)
        val bodies = List(3) { block(depth - 1, isInLoop = false) }
        val text = "switch ((${selector.text}) & 3) { case 0: ${bodies[0].text} case 1: ${bodies[1].text} break; " +
            "default: ${bodies[2].text} }"
        return TestStatement(text) {
            when (selector.valueIn(it) and 3) {
                0 -> {
                    bodies[0].run(it)
                    bodies[1].run(it)
                }

                1 -> bodies[1].run(it)
                else -> bodies[2].run(it)
            }
        }
    }

    /** A branch over more code than a short jump reaches. */
    private fun longBranch(): TestStatement {
        val condition = expressions.next(1)
        val name = variables.random(random)
        val times = random.nextInt(20, 60)
        return TestStatement("if (${condition.text}) { ${"$name += 3; ".repeat(times)} }") {
            if (condition.valueIn(it) != 0) it[name] = (it.getValue(name) + times * 3).toShort().toInt()
            TestFlow.GO_ON
        }
    }

    private fun counter() = "n${counters.size}".also { counters += it }
}
