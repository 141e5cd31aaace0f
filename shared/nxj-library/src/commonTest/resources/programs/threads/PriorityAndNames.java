public class PriorityAndNames {
    public static void main(String[] arguments) throws InterruptedException {
        System.out.println(Thread.MIN_PRIORITY + " " + Thread.NORM_PRIORITY + " " + Thread.MAX_PRIORITY);
        Thread child = new Thread(new Runnable() {
            public void run() {
                System.out.println(Thread.currentThread().getName() + " " + Thread.currentThread().getPriority());
            }
        }, "child");
        child.setPriority(8);
        System.out.println(child.getPriority() + " " + child.getName() + " " + child.isDaemon());
        child.setName("renamed");
        child.start();
        child.join();
        Thread own = new Thread("own") {
            @Override
            public void run() {
                setPriority(2);
                System.out.println(getName() + " " + getPriority() + " " + (Thread.currentThread() == this));
            }
        };
        own.start();
        own.join();
        Thread nothing = new Thread();
        nothing.start();
        nothing.join();
        System.out.println(nothing.isAlive());
    }
}

// It prints:
// expect 1 5 10
// expect 8 child false
// expect renamed 8
// expect own 2 true
// expect false
