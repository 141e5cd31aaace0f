public class MemoryIsNeverEnough {
    static Object[] kept;

    public static void main(String[] arguments) {
        while (true) {
            try {
                Object[] next = new Object[10];
                next[0] = kept;
                kept = next;
            } catch (Throwable full) {
                continue;
            }
        }
    }
}
// runs on after 500
