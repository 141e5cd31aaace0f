// only here
public class NumbersOfPlainClasses {
    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(boolean.class + ", " + char.class + ", " + float.class + ", " + double.class); // expect class 4, class 5, class 6, class 7
        System.out.println(byte.class + ", " + short.class + ", " + int.class + ", " + long.class); // expect class 8, class 9, class 10, class 11
        System.out.println(void.class); // expect class 12
        System.out.println(new java.awt.Rectangle(1, 2, 3, 4)); // expect Rectangle[x=1,y=2,width=3,height=4]
        Object lock = new Object();
        long start = System.currentTimeMillis();
        synchronized (lock) {
            lock.wait(20, 1);
        }
        long passed = System.currentTimeMillis() - start;
        System.out.println(passed >= 21 && passed <= 23); // expect true
        Thread hook = new Thread() {
            public void run() {
                System.out.println("never");
            }
        };
        Runtime.getRuntime().addShutdownHook(hook);
        System.out.println(Runtime.getRuntime().removeShutdownHook(hook) + " " + Runtime.getRuntime().removeShutdownHook(hook)); // expect true false
    }
}
