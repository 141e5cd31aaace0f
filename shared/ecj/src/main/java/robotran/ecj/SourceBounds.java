package robotran.ecj;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.jdt.core.compiler.InvalidInputException;
import org.eclipse.jdt.internal.compiler.parser.Scanner;
import org.eclipse.jdt.internal.compiler.parser.TerminalTokens;

/**
 * Detects sources that are too deep or too large for the compiler before it reads them. The compiler walks its tree
 * recursively, and not every platform can catch a stack overflow. Each token since the end of the last statement may
 * add a level ({@code !!!!x}, {@code a + b + c}, {@code if (a) if (b)}), and so may each {@code else} of a chain.
 */
final class SourceBounds {
    /**
     * Max depth of the compiler's tree: far more than a program needs, and a third of what the smallest stack allows.
     */
    static final int LEVELS = 1_000;

    /** Max nested brackets. */
    static final int BRACKETS = 120;

    /** Max imports of a source. The compiler may look for each name in each of them. */
    static final int IMPORTS = 300;

    /** Max classes and interfaces of a program. A brick takes fewer, and they may all extend one another. */
    static final int TYPES = 500;

    private final String path;
    private final List<Integer> levelsOutside = new ArrayList<>();
    private final FinallyCopies copies;
    private EcjProblem problem;
    private int levels;
    private int elses;
    private boolean statementEnded;
    private int imports;
    private int types;
    private int tokenBefore;

    /**
     * @param types the classes and interfaces in the sources before this one
     * @param copiesFinally see {@link BrickTarget#copiesFinally}
     */
    SourceBounds(String path, String source, int types, boolean copiesFinally) {
        this.path = path;
        this.types = types;
        this.copies = copiesFinally ? new FinallyCopies() : null;
        scan(source);
    }

    /** What exceeds a bound first; null if nothing does. */
    EcjProblem problem() {
        return problem;
    }

    /** The classes and interfaces in this source and those before it. */
    int typeCount() {
        return types;
    }

    private void scan(String source) {
        Scanner scanner = new Scanner();
        scanner.setSource(source.toCharArray());
        for (int before = -1; scanner.currentPosition > before && problem == null;) {
            before = scanner.currentPosition;
            int token;
            try {
                token = scanner.getNextToken();
            } catch (InvalidInputException unreadable) {
                continue;
            }
            if (token == TerminalTokens.TokenNameEOF) {
                return;
            }
            countLevels(token);
            countDeclarations(token);
            int copied = copies == null ? -1 : copies.tooManyAt(token, scanner.startPosition);
            int start = scanner.startPosition;
            int end = scanner.currentPosition;
            if (levels > LEVELS || levelsOutside.size() > BRACKETS) {
                problem = EcjProblem.of(path, BrickProblem.NESTED_TOO_DEEPLY, start, end);
            } else if (imports > IMPORTS) {
                problem = EcjProblem.of(path, BrickProblem.TOO_MANY_IMPORTS, start, end, Integer.toString(IMPORTS));
            } else if (types > TYPES) {
                problem = EcjProblem.of(path, BrickProblem.TOO_MANY_CLASSES, start, end, Integer.toString(TYPES));
            } else if (copied >= 0) {
                problem = EcjProblem.of(
                    path, BrickProblem.FINALLY_COPIED_TOO_OFTEN, copied, copied + "finally".length());
            }
        }
    }

    private void countDeclarations(int token) {
        boolean isLiteral = tokenBefore == TerminalTokens.TokenNameDOT; // Such as int.class.
        if (token == TerminalTokens.TokenNameimport) {
            imports++;
        } else if (token == TerminalTokens.TokenNameinterface
                || token == TerminalTokens.TokenNameclass && !isLiteral) {
            types++;
        }
        tokenBefore = token;
    }

    private void countLevels(int token) {
        if (statementEnded) {
            elses = token == TerminalTokens.TokenNameelse ? elses + 1 : 0;
            statementEnded = false;
        }
        switch (token) {
            case TerminalTokens.TokenNameLPAREN:
            case TerminalTokens.TokenNameLBRACE:
            case TerminalTokens.TokenNameLBRACKET:
                levelsOutside.add(levels);
                levels++;
                break;
            case TerminalTokens.TokenNameRPAREN:
            case TerminalTokens.TokenNameRBRACKET:
                leave();
                levels++;
                break;
            case TerminalTokens.TokenNameRBRACE:
                leave();
                endStatement();
                break;
            case TerminalTokens.TokenNameSEMICOLON:
                endStatement();
                break;
            case TerminalTokens.TokenNameCOMMA:
                levels = levelsAround();
                break;
            default:
                levels++;
        }
    }

    private void endStatement() {
        levels = levelsAround() + elses;
        statementEnded = true;
    }

    private void leave() {
        if (!levelsOutside.isEmpty()) {
            levels = levelsOutside.remove(levelsOutside.size() - 1);
        }
    }

    private int levelsAround() {
        return levelsOutside.isEmpty() ? 0 : levelsOutside.get(levelsOutside.size() - 1);
    }
}
