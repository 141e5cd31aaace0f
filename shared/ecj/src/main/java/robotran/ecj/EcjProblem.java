package robotran.ecj;

import java.util.List;

/**
 * Something that the compiler or {@link BrickRules} find wrong, as they see it; the words for a pupil are found
 * elsewhere.
 */
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

    /** The path of the source it is in. */
    public String path() {
        return path;
    }

    /** Its kind: ECJ's number without the bits for the category, or one of {@link BrickProblem}, which are below 0. */
    public int number() {
        return number;
    }

    /** Whether it keeps the program from running. */
    public boolean error() {
        return error;
    }

    /** Whether the source could not even be read there. */
    public boolean syntax() {
        return syntax;
    }

    /** The place of the first character, counted from 0 in UTF-16 units. */
    public int start() {
        return start;
    }

    /** The place behind the last character. */
    public int end() {
        return end;
    }

    /** ECJ's own English sentence, empty for the brick's rules. */
    public String message() {
        return message;
    }

    /** The names and types it is about, written short, in an order that depends on the kind. */
    public List<String> arguments() {
        return arguments;
    }

    /** For a method or field that a class of the library has not: the names of those it has, in alphabetical order. */
    public List<String> members() {
        return members;
    }
}
