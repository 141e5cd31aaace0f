package robotran.ecj;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** A problem that the compiler or {@link BrickRules} found. The message for the pupil is made elsewhere. */
public final class EcjProblem {
    private final String path;
    private final int number;
    private final boolean error;
    private final boolean syntax;
    private final int start;
    private final int end;
    private final String message;
    private final List<String> arguments;
    private final List<String> members;

    EcjProblem(
            String path,
            int number,
            boolean error,
            boolean syntax,
            int start,
            int end,
            String message,
            List<String> arguments,
            List<String> members) {
        this.path = path;
        this.number = number;
        this.error = error;
        this.syntax = syntax;
        this.start = start;
        this.end = end;
        this.message = message;
        this.arguments = arguments;
        this.members = members;
    }

    /** An error that ECJ itself does not know, of a kind in {@link BrickProblem}. */
    static EcjProblem of(String path, int number, int start, int end, String... arguments) {
        return new EcjProblem(
            path, number, true, false, start, end, "", Arrays.asList(arguments), Collections.emptyList());
    }

    /** The path of the source. */
    public String path() {
        return path;
    }

    /** The kind: ECJ's problem id without category bits, or an id of {@link BrickProblem}, which is negative. */
    public int number() {
        return number;
    }

    /** Whether it prevents the program from running. */
    public boolean error() {
        return error;
    }

    /** Whether the source could not be parsed there. */
    public boolean syntax() {
        return syntax;
    }

    /** The index of the first character, from 0 in UTF-16 units. */
    public int start() {
        return start;
    }

    /** The index after the last character. */
    public int end() {
        return end;
    }

    /** ECJ's English message, empty for the brick's rules. */
    public String message() {
        return message;
    }

    /** The names and types in the message, in short form; their order depends on the kind. */
    public List<String> arguments() {
        return arguments;
    }

    /** For an unknown method or field of a library class: the names that the class has, in alphabetical order. */
    public List<String> members() {
        return members;
    }
}
