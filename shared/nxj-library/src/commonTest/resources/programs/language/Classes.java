public class Classes {
    static class Account {
        private static int accounts = 0;
        private int balance;
        final int number;

        Account(int balance) {
            this.balance = balance;
            number = ++accounts;
        }

        Account() {
            this(100);
        }

        void pay(int amount) {
            balance += amount;
        }

        int balance() {
            return balance;
        }
    }

    public static void main(String[] arguments) {
        Account mine = new Account();
        Account yours = new Account(5);
        mine.pay(20);
        System.out.println(mine.balance()); // expect 120
        System.out.println(yours.balance()); // expect 5
        System.out.println(yours.number); // expect 2
        System.out.println(Account.accounts); // expect 2
    }
}
