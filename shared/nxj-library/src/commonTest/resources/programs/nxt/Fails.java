/** An exception that nobody catches. */
public class Fails {
    static int[] numbers = new int[3];

    public static void main(String[] args) throws Exception {
        System.out.println("before"); // screen before
        Thread.sleep(300);
        set(5);
        System.out.println("after");
    }

    static void set(int index) {
        numbers[index] = 1; // fails ArrayIndexOutOfBoundsException
    }
}
// expect before
