import josx.platform.rcx.LCD;

public class SystemAndRuntime {
    public static void main(String[] arguments) {
        Runtime runtime = Runtime.getRuntime();
        LCD.showNumber(runtime == System.getRuntime() ? 1 : 0); // shows: 1
        int free = (int) runtime.freeMemory();
        int all = (int) runtime.totalMemory();
        LCD.showNumber(free > 0 && free <= all ? 1 : 0); // shows: 1
        LCD.showNumber((int) System.currentTimeMillis() < 0 ? 1 : 0); // shows: 0
    }
}
