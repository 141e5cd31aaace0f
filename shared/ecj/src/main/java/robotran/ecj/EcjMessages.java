package robotran.ecj;

import java.io.IOException;
import java.io.InputStream;
import java.util.Locale;
import java.util.Properties;
import org.eclipse.jdt.core.compiler.CategorizedProblem;
import org.eclipse.jdt.core.compiler.IProblem;
import org.eclipse.jdt.internal.compiler.IProblemFactory;
import org.eclipse.jdt.internal.compiler.problem.DefaultProblem;

/**
 * Creates ECJ's problems with English messages. It uses no resource bundles, which depend on the platform's language.
 */
final class EcjMessages implements IProblemFactory {
    private static final String TEXTS = "/org/eclipse/jdt/internal/compiler/problem/messages.properties";

    private final Properties texts = new Properties();

    EcjMessages() {
        try (InputStream file = EcjMessages.class.getResourceAsStream(TEXTS)) {
            texts.load(file);
        } catch (IOException unreadable) {
            throw new IllegalStateException("ECJ's messages cannot be read.", unreadable);
        }
    }

    @Override
    public CategorizedProblem createProblem(
            char[] path, int id, String[] names, String[] shortNames, int severity, int start, int end, int line,
            int column) {
        return createProblem(path, id, names, 0, shortNames, severity, start, end, line, column);
    }

    /** Keeps the short names as the problem's arguments, because the messages contain them. */
    @Override
    public CategorizedProblem createProblem(
            char[] path, int id, String[] names, int elaboration, String[] shortNames, int severity, int start, int end,
            int line, int column) {
        String[] known = withoutNulls(shortNames);
        String message = getLocalizedMessage(id, elaboration, known);
        return new DefaultProblem(path, message, id, known, severity, start, end, line, column);
    }

    /** The names of newer Java features are null, because only ECJ's command line sets them. */
    private static String[] withoutNulls(String[] names) {
        if (names == null) {
            return null;
        }
        String[] known = names.clone();
        for (int place = 0; place < known.length; place++) {
            known[place] = known[place] == null ? "" : known[place];
        }
        return known;
    }

    @Override
    public Locale getLocale() {
        return Locale.ENGLISH;
    }

    @Override
    public String getLocalizedMessage(int id, String[] shortNames) {
        return getLocalizedMessage(id, 0, shortNames);
    }

    @Override
    public String getLocalizedMessage(int id, int elaboration, String[] shortNames) {
        String text = text(id);
        if (elaboration != 0) {
            text = text.replace("{0}", text(elaboration));
        }
        text = text.replace("''", "'");
        if (shortNames == null) {
            return text;
        }
        StringBuilder filled = new StringBuilder();
        int copied = 0;
        for (int open = text.indexOf('{'); open >= 0; open = text.indexOf('{', copied)) {
            int close = text.indexOf('}', open);
            int place = close == open + 2 ? text.charAt(open + 1) - '0' : -1;
            boolean known = place >= 0 && place < shortNames.length;
            filled.append(text, copied, open).append(known ? shortNames[place] : "{");
            copied = known ? close + 1 : open + 1;
        }
        return filled.append(text, copied, text.length()).toString();
    }

    private String text(int id) {
        return texts.getProperty(Integer.toString(id & IProblem.IgnoreCategoriesMask), "");
    }
}
