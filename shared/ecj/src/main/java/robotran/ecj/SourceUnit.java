package robotran.ecj;

import org.eclipse.jdt.internal.compiler.env.ICompilationUnit;

/** One source file in memory. */
final class SourceUnit implements ICompilationUnit {
    private final String path;
    private final char[] contents;

    SourceUnit(String path, String text) {
        this.path = path;
        this.contents = text.toCharArray();
    }

    @Override
    public char[] getFileName() {
        return path.toCharArray();
    }

    @Override
    public char[] getContents() {
        return contents;
    }

    /** The required name of a public class in this file. */
    @Override
    public char[] getMainTypeName() {
        String name = path.substring(path.lastIndexOf('/') + 1);
        return (name.endsWith(".java") ? name.substring(0, name.length() - ".java".length()) : name).toCharArray();
    }

    /** Unknown before parsing; a source may be in any folder. */
    @Override
    public char[][] getPackageName() {
        return null;
    }
}
