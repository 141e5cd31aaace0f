import josx.platform.rcx.LCD;

public class MemoryShrinks {
    public static void main(String[] arguments) {
        int before = (int) System.getRuntime().freeMemory();
        int[] numbers = new int[100];
        int after = (int) System.getRuntime().freeMemory();
        LCD.showNumber(before - after >= numbers.length * 4 ? 1 : 0); // shows: 1
    }
}
