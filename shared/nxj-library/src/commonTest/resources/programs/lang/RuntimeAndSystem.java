public class RuntimeAndSystem {
    public static void main(String[] arguments) {
        System.out.println(arguments.length); // expect 0
        long before = System.currentTimeMillis();
        long nanos = System.nanoTime();
        int sum = 0;
        for (int i = 0; i < 20000; i++) sum += i;
        System.out.println(sum); // expect 199990000
        System.out.println(System.currentTimeMillis() >= before); // expect true
        System.out.println(System.nanoTime() >= nanos); // expect true
        Runtime runtime = Runtime.getRuntime();
        System.out.println(runtime.freeMemory() > 0 && runtime.totalMemory() >= runtime.freeMemory()); // expect true
        System.gc();
        System.out.println(System.getProperty("no.such.key")); // expect null
        int[] source = {1, 2, 3, 4, 5};
        System.arraycopy(source, 0, source, 1, 4);
        for (int number : source) sum = sum * 7 + number;
        System.out.println(sum); // expect -1727459901
        try {
            System.arraycopy(source, 0, new int[2], 0, 3);
        } catch (IndexOutOfBoundsException wrong) {
            System.out.println("index"); // expect index
        }
        try {
            System.arraycopy(source, 0, new long[9], 0, 3);
        } catch (ArrayStoreException wrong) {
            System.out.println("kind"); // expect kind
        }
        Runtime.getRuntime().addShutdownHook(new Thread() {
            @Override
            public void run() {
                RuntimeAndSystem.class.hashCode();
            }
        });
    }
}
