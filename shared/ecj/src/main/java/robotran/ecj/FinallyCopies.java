package robotran.ecj;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.jdt.internal.compiler.parser.TerminalTokens;

/**
 * Finds each {@code finally} whose code would be copied too often, from the tokens of a source. A copy is at each end
 * of the {@code try} and its {@code catch}es, at each {@code return}, {@code break} and {@code continue} in them, and
 * where an exception leaves them. So the code doubles at least with each {@code finally} inside another.
 */
final class FinallyCopies {
    /** Max tokens of a {@code finally} and its copies. A method that holds as many is too long for a class file. */
    static final long TOKENS = 60_000;

    private final List<Block> open = new ArrayList<>();
    private Block current = new Block(-1, 0);
    private int next = -1;
    private int nextStart;

    /** The start of a {@code finally} that ends with {@code token} and has too many copies, or -1. */
    int tooManyAt(int token, int start) {
        boolean isPart = next < 0 && token == TerminalTokens.TokenNamecatch || token == TerminalTokens.TokenNamefinally;
        if (!isPart && next < 0) {
            current.closeTry();
        }
        current.tokens++;
        switch (token) {
            case TerminalTokens.TokenNametry:
            case TerminalTokens.TokenNamecatch:
            case TerminalTokens.TokenNamefinally:
                next = token;
                nextStart = start;
                break;
            case TerminalTokens.TokenNamereturn:
            case TerminalTokens.TokenNamebreak:
            case TerminalTokens.TokenNamecontinue:
                current.exits++;
                break;
            case TerminalTokens.TokenNameLBRACE:
                open.add(current);
                current = new Block(next, nextStart);
                next = -1;
                break;
            case TerminalTokens.TokenNameRBRACE:
                return leave();
            default:
                break;
        }
        return -1;
    }

    private int leave() {
        if (open.isEmpty()) {
            return -1;
        }
        Block left = current;
        left.closeTry();
        current = open.remove(open.size() - 1);
        switch (left.kind) {
            case TerminalTokens.TokenNametry:
            case TerminalTokens.TokenNamecatch:
                current.tokens += left.tokens;
                current.tryExits += left.exits;
                current.tryEnds++;
                return -1;
            case TerminalTokens.TokenNamefinally:
                long copies = current.tryExits + current.tryEnds + 1;
                current.tokens += left.tokens * copies;
                current.exits += left.exits * copies;
                return left.tokens * copies > TOKENS ? left.start : -1;
            default:
                current.tokens += left.tokens;
                current.exits += left.exits;
                return -1;
        }
    }

    /** What is between braces, with its copies. */
    private static final class Block {
        final int kind;
        final int start;
        long tokens;

        /** Statements that leave it, or at least may. */
        long exits;

        /** Those of the last try in it and its catches. */
        long tryExits;
        long tryEnds;

        Block(int kind, int start) {
            this.kind = kind;
            this.start = start;
        }

        void closeTry() {
            exits += tryExits;
            tryExits = 0;
            tryEnds = 0;
        }
    }
}
