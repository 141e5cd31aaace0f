package robotran.ecj;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.jdt.core.compiler.InvalidInputException;
import org.eclipse.jdt.internal.compiler.parser.Scanner;
import org.eclipse.jdt.internal.compiler.parser.TerminalTokens;

/**
 * Detects sources that are nested too deeply before the compiler reads them. The compiler walks its tree recursively,
 * and not every platform can catch a stack overflow. Each token since the end of the last statement may add a level
 * ({@code !!!!x}, {@code a + b + c}, {@code if (a) if (b)}), and so may each {@code else} of a chain.
 */
final class SourceBounds {
    /**
     * Max depth of the compiler's tree: far more than a program needs, and a third of what the smallest stack allows.
     */
    static final int LEVELS = 1_000;

    /** Max nested brackets. */
    static final int BRACKETS = 120;

    private final List<Integer> levelsOutside = new ArrayList<>();
    private int levels;
    private int elses;
    private boolean statementEnded;

    /** The index of the first token that is nested too deeply, or -1. */
    static int tooDeep(String source) {
        return new SourceBounds().scan(source);
    }

    private int scan(String source) {
        Scanner scanner = new Scanner();
        scanner.setSource(source.toCharArray());
        for (int before = -1; scanner.currentPosition > before;) {
            before = scanner.currentPosition;
            int token;
            try {
                token = scanner.getNextToken();
            } catch (InvalidInputException unreadable) {
                continue;
            }
            if (token == TerminalTokens.TokenNameEOF) {
                return -1;
            }
            count(token);
            if (levels > LEVELS || levelsOutside.size() > BRACKETS) {
                return scanner.startPosition;
            }
        }
        return -1;
    }

    private void count(int token) {
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
