import josx.platform.rcx.LCD;

public class EverythingIsKept {
    static class Link {
        final Link before;

        Link(Link before) {
            this.before = before;
        }
    }

    public static void main(String[] arguments) {
        Link last = null;
        while (true) last = new Link(last);
    }
}
// fails 14 OutOfMemoryError
