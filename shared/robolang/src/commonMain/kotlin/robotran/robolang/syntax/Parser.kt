package robotran.robolang.syntax

import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.BrickDialect
import robotran.robolang.words.Keyword
import robotran.robolang.words.OPENERS
import robotran.robolang.words.OUTERMOST
import robotran.robolang.words.SETTINGS
import robotran.robolang.words.lowercaseKeyword

/**
 * Builds the syntax tree by recursive descent, with one function per rule of the grammar in docs/robolang.md. After an
 * error, the parser skips the rest of the line and continues with the next one. Blocks are kept on an explicit stack,
 * so that nesting never overflows the host's stack.
 */
internal class Parser(private val lines: List<ScannedLine>, private val diagnostics: DiagnosticSink) {
    private val blocks = OpenBlocks()
    private val messages = diagnostics.messages
    private val names = mutableListOf<Name>()
    private val edges = mutableMapOf<Int, BlockEdge>()
    private val routines = mutableListOf<Routine>()
    private val behaviours = mutableListOf<Behaviour>()
    private val routineNames = routineNamesIn(lines)
    private var robot: RobotHeader? = null
    private var settings = mutableListOf<RobotSetting>()

    init {
        diagnostics.declaredNames = lines.flatMapTo(mutableSetOf()) { declaredNames(it.tokens) }
    }

    fun program(): ParsedProgram {
        val written = lines.filter { it.tokens.isNotEmpty() }
        written.forEachIndexed { index, line -> line(LineReader(line, written.getOrNull(index + 1))) }
        forgiveTakenWords(lines, diagnostics)
        val lacking = blocks.lackingEnds()
        reportMissingEnds(lacking, lines, diagnostics)
        val endColumn = lines.last().text.length + 1
        val statements = blocks.program(SourceRange(lines.size, endColumn, endColumn))
        val tree =
            SyntaxTree(
                robot,
                routines.sortedBy { it.range.line },
                behaviours,
                statements,
                lines.mapNotNull { it.comment },
            )
        return ParsedProgram(tree, lines, names, blocks.isUncertain || lacking.isNotEmpty(), edges, lacking)
    }

    private fun line(reader: LineReader) {
        val keyword = reader.first.keyword
        closeLackingBefore(reader)
        when {
            reader.peek(
                1,
            )?.kind == TokenKind.ASSIGN && !reader.first.canBeName && keyword != null -> reservedWord(reader)
            keyword == Keyword.END -> end(reader)
            keyword == Keyword.ELSE -> otherwise(reader)
            blocks.innermost?.keyword?.keyword == Keyword.ROBOT -> setting(reader)
            keyword in OPENERS -> open(reader)
            else -> statement(reader)?.let(blocks::add)
        }
        names += reader.names
    }

    /**
     * A routine, and any line that is not indented further than `robot`, shows that the previous blocks should have
     * ended.
     */
    private fun closeLackingBefore(reader: LineReader) {
        val first = reader.first
        val column = first.range.column
        if (first.keyword in OUTERMOST) {
            blocks.closeLacking(first.range.line) { it.keyword.range.column >= column }
        } else if (first.keyword != Keyword.END) {
            if (!maybeSetting(reader)) {
                blocks.closeLacking(first.range.line) {
                    it.keyword.keyword == Keyword.ROBOT &&
                        it.keyword.range.column >= column
                }
            }
        }
    }

    private fun statement(reader: LineReader): Statement? {
        val begunWithName = reader.first.canBeName && reader.peek(1)?.kind?.text != null
        val statement = when {
            begunWithName -> DataParser(reader, diagnostics).named()
            reader.first.keyword in DataParser.COMMANDS -> DataParser(reader, diagnostics).statement()
            reader.first.keyword in Keyword.COMMANDS -> CommandParser(reader, diagnostics).command()
            else -> noCommand(reader)
        }
        if (statement != null) diagnostics.expectEndOfLine(reader)
        return statement
    }

    private fun noCommand(reader: LineReader): Nothing? {
        when (diagnostics.reportNoCommand(reader, routineNames)) {
            BlockEffect.NONE -> Unit
            BlockEffect.MAY_OPEN -> openUnknown(reader)
            BlockEffect.CLOSES -> closeUnsurely(reader)
        }
        return null
    }

    private fun closeUnsurely(reader: LineReader) {
        blocks.closeUnsurely(reader.first)
        edges[reader.line.number] = BlockEdge.CLOSES
    }

    private fun openUnknown(reader: LineReader) {
        blocks.openUnknown()
        edges[reader.line.number] = BlockEdge.MAY_OPEN
    }

    private fun reservedWord(reader: LineReader) {
        val word = reader.first
        diagnostics.report(
            reader,
            DiagnosticCode.RESERVED_WORD,
            word.range,
            messages.reservedWord(shortened(word.text)),
        )
    }

    private fun open(reader: LineReader) {
        val keyword = reader.first
        edges[reader.line.number] = BlockEdge.OPENS
        if (blocks.isFull && !blocks.isOverfull) diagnostics.reportNesting(reader, keyword)
        val isNested = keyword.keyword in OUTERMOST && blocks.innermost != null
        if (isNested) {
            diagnostics.report(
                reader,
                DiagnosticCode.NOT_OUTERMOST,
                keyword.range,
                messages.notOutermost(shortened(keyword.text)),
            )
        }
        val headers = HeaderParser(reader, diagnostics)
        if (keyword.keyword != Keyword.REPEAT && keyword.keyword != Keyword.FOR) reader.advance()
        blocks.open(
            when (keyword.keyword) {
                Keyword.IF -> choice(reader, headers)
                Keyword.WHENEVER -> whenever(reader, headers)
                Keyword.PROCEDURE, Keyword.FUNCTION -> routine(reader, headers)
                Keyword.ROBOT -> robot(reader)
                else -> headers.loop().let { complete -> OpenBlock(keyword, reader.readRange, complete = complete) }
            },
        )
        if (reader.line.number !in diagnostics.lines) diagnostics.expectEndOfLine(reader)
    }

    private fun choice(reader: LineReader, headers: HeaderParser): OpenBlock {
        val condition = headers.conditionOrAny()
        val choice = OpenChoice(reader.readRange, condition)
        return OpenBlock(reader.first, reader.readRange, choice, choice::complete)
    }

    private fun whenever(reader: LineReader, headers: HeaderParser): OpenBlock {
        val condition = headers.conditionOrAny()
        return OpenBlock(reader.first, reader.readRange) { block ->
            behaviours += Behaviour(block.range, block.endRange, condition, block.body)
            null
        }
    }

    private fun routine(reader: LineReader, headers: HeaderParser): OpenBlock {
        val isFunction = reader.first.keyword == Keyword.FUNCTION
        val header = headers.routine()
        return OpenBlock(reader.first, reader.readRange) { block ->
            routines += Routine(block.range, block.endRange, header.name, header.parameters, block.body, isFunction)
            null
        }
    }

    private fun robot(reader: LineReader): OpenBlock {
        if (robot != null) {
            diagnostics.report(reader, DiagnosticCode.SECOND_ROBOT, reader.first.range, messages.secondRobot())
        }
        return OpenBlock(reader.first, reader.readRange) { block ->
            robot = robot ?: RobotHeader(block.range, block.endRange, settings)
            null
        }
    }

    private fun setting(reader: LineReader) {
        if (reader.first.keyword !in SETTINGS) {
            diagnostics.report(reader, DiagnosticCode.UNKNOWN_SETTING, reader.first.range, messages.unknownSetting())
            if (reader.first.keyword in OPENERS) openUnknown(reader)
            return
        }
        val setting = HeaderParser(reader, diagnostics).setting() ?: return
        val severalOfAKind = BrickDialect.of(diagnostics.brick).hasSeveralOfAKind
        val isFirst = settings.none { it.excludes(setting, severalOfAKind) }
        if (!isFirst && robot == null) {
            val message = when (setting) {
                is LightSensorSetting -> messages.secondSetting()
                is SensorSetting -> messages.settingTwice(setting.sensor.settingOn(setting.port))
                is BrickSetting -> messages.settingTwice(Keyword.BRICK.text)
            }
            diagnostics.report(reader, DiagnosticCode.UNKNOWN_SETTING, reader.first.range, message)
        }
        settings += setting
    }

    private fun otherwise(reader: LineReader) {
        if (blocks.hasOpenChoice) blocks.closeLacking(reader.line.number) { it.choice == null }
        val block = blocks.innermost
        val choice = block?.choice
        reader.advance()
        val condition = if (reader.take(Keyword.IF) != null) {
            HeaderParser(reader, diagnostics).conditionOrAny()
        } else {
            null
        }
        edges[reader.line.number] = if (condition == null) BlockEdge.ELSE else BlockEdge.ELSE_IF
        if (choice == null || choice.isAtElse) {
            diagnostics.report(reader, DiagnosticCode.EXTRA_ELSE, reader.first.range, messages.extraElse())
            return
        }
        choice.next(block.statements, reader.readRange, condition)
        block.statements = mutableListOf()
        if (reader.line.number !in diagnostics.lines) diagnostics.expectEndOfLine(reader)
    }

    private fun end(reader: LineReader) {
        val keyword = reader.first
        edges[reader.line.number] = BlockEdge.CLOSES
        reader.take(Keyword.END)
        if (blocks.close(keyword)) diagnostics.expectEndOfLine(reader) else diagnostics.reportExtraEnd(reader)
    }
}

/** The names of all routines, to recognise a call without brackets. */
private fun routineNamesIn(lines: List<ScannedLine>): Set<String> = lines
    .filter {
        it.tokens.firstOrNull()?.keyword.let { keyword ->
            keyword == Keyword.PROCEDURE ||
                keyword == Keyword.FUNCTION
        }
    }
    .mapNotNullTo(mutableSetOf()) { line -> line.tokens.getOrNull(1)?.text?.let(::lowercaseKeyword) }
