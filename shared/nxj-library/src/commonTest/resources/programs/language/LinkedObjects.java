public class LinkedObjects {
    static class Wagon {
        final int load;
        Wagon next;

        Wagon(int load, Wagon next) {
            this.load = load;
            this.next = next;
        }
    }

    public static void main(String[] arguments) {
        Wagon train = null;
        for (int load = 1; load <= 4; load++) train = new Wagon(load, train);
        int sum = 0;
        for (Wagon wagon = train; wagon != null; wagon = wagon.next) sum = sum * 10 + wagon.load;
        System.out.println(sum); // expect 4321
    }
}
